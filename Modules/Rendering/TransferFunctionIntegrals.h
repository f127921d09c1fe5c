/**
 * @file    TransferFunctionIntegrals.h
 * @brief   how much extinction and colour a table of transfer functions has up to each entry
 */

#ifndef TransferFunctionIntegrals_h
#define TransferFunctionIntegrals_h

#include "TransferFunctionTable.h"

namespace penumbra
{

/// Adds to a table of extinctions and colours their integrals, exact where the functions are
/// straight lines between their points, and tells whether the functions are steep.
void FillIntegrals(const TransferFunctions& functions, TransferFunctionTable& table);

}

#endif
