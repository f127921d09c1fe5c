/**
 * @file    FunctionNodes.h
 * @brief   points of the scene's functions to and from VTK's functions, which charts edit
 */

#ifndef FunctionNodes_h
#define FunctionNodes_h

#include "SceneDescription.h"

class vtkColorTransferFunction;
class vtkPiecewiseFunction;

namespace penumbra
{

/// Their values within 0 to 1.
///@{
FunctionPoints<1> PointsOf(vtkPiecewiseFunction* function);
FunctionPoints<3> PointsOf(vtkColorTransferFunction* function);
///@}

/// Modifies the function only where it has other points.
///@{
void ShowPoints(const FunctionPoints<1>& points, vtkPiecewiseFunction* function);
void ShowPoints(const FunctionPoints<3>& points, vtkColorTransferFunction* function);
///@}

}

#endif
