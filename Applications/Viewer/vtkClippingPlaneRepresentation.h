/**
 * @class   vtkClippingPlaneRepresentation
 * @brief   a clipping plane as its edge on the volume's bounds, a ball and an arrow
 *
 * The ball and the edge push the plane along its normal, the arrow turns it. The face of the plane,
 * which may fill the view, is left to the camera. Of several planes one has ball and arrow.
 */

#ifndef vtkClippingPlaneRepresentation_h
#define vtkClippingPlaneRepresentation_h

#include <vtkImplicitPlaneRepresentation.h>

class vtkClippingPlaneRepresentation : public vtkImplicitPlaneRepresentation
{
public:
  static vtkClippingPlaneRepresentation* New();
  vtkTypeMacro(vtkClippingPlaneRepresentation, vtkImplicitPlaneRepresentation);

  void SetHandles(bool shown);

  int ComputeInteractionState(int x, int y, int modify = 0) override;

protected:
  vtkClippingPlaneRepresentation();
  ~vtkClippingPlaneRepresentation() override = default;

private:
  vtkClippingPlaneRepresentation(const vtkClippingPlaneRepresentation&) = delete;
  void operator=(const vtkClippingPlaneRepresentation&) = delete;
};

#endif
