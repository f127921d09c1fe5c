/**
 * @file    ScalarEncoding.h
 * @brief   a volume's scalars as the values of a texture
 *
 * Scalars of 8 and 16 bits become 16-bit normalized values, all others floats: some drivers filter
 * 8-bit textures with 8 bits, which shows under steep transfer functions. Floats are stored
 * relative to an offset where the data's values are large against their range, and divided by a
 * scale where they are beyond single precision. NaN and -Inf count as the smallest finite value,
 * +Inf as the largest.
 */

#ifndef ScalarEncoding_h
#define ScalarEncoding_h

#include "ScalarRange.h"

#include <vector>

class vtkDataArray;

namespace penumbra
{

/// The affine map between scalars and what a texture of them returns: scalar = Scale * value +
/// Offset.
struct ScalarEncoding
{
  bool Normalized = false; ///< 16-bit normalized values; else floats
  double Scale = 1.0;
  double Offset = 0.0;
};

/// scalarType: VTK's, as VTK_SHORT.
ScalarEncoding ChooseEncoding(int scalarType, const ScalarRange& range);

/// Values for a texture of that encoding, one a voxel.
std::vector<unsigned short> EncodeNormalized(vtkDataArray* scalars, const ScalarEncoding& encoding);
std::vector<float> EncodeFloat(
  vtkDataArray* scalars, const ScalarEncoding& encoding, const ScalarRange& range);

}

#endif
