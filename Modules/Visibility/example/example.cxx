#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>
#include <vtkRTAnalyticSource.h>
#include <vtkVolumeLight.h>
#include <vtkVolumeProperty.h>
#include <vtkVolumeVisibilityFilter.h>
#include <vtkXMLImageDataWriter.h>

#include <iostream>

int main(int argc, char* argv[])
{
  vtkNew<vtkRTAnalyticSource> source; // or any reader of volumes
  source->SetWholeExtent(-32, 32, -32, 32, -32, 32);

  vtkNew<vtkPiecewiseFunction> opacity; // per unit distance
  opacity->AddPoint(100, 0.0);
  opacity->AddPoint(250, 0.2);
  vtkNew<vtkVolumeProperty> property; // or volume->GetProperty()
  property->SetScalarOpacity(opacity);
  property->SetScalarOpacityUnitDistance(1.0);
  property->SetInterpolationTypeToLinear();

  vtkNew<vtkVolumeLight> sun; // shines from (1, 2, 3) towards the origin
  sun->SetPosition(1, 2, 3);
  sun->SetShadowToSoft();
  vtkNew<vtkVolumeLight> lamp; // inside the volume
  lamp->PositionalOn();
  lamp->SetConeAngle(90);
  lamp->SetPosition(10, 0, 0);
  lamp->SetShadowToHard();

  vtkNew<vtkVolumeVisibilityFilter> visibility;
  visibility->SetInputConnection(source->GetOutputPort());
  visibility->SetVolumeProperty(property);
  visibility->AddLight(sun); // or SetLights(renderer->GetLights())
  visibility->AddLight(lamp);
  visibility->SetResolution(0.5); // a point for every second voxel

  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetInputConnection(visibility->GetOutputPort());
  writer->SetFileName(argc > 1 ? argv[1] : "visibility.vti");
  if (!writer->Write())
  {
    return 1;
  }
  vtkPointData* arrays = visibility->GetOutput()->GetPointData();
  for (int array = 0; array < arrays->GetNumberOfArrays(); ++array)
  {
    const double* range = arrays->GetArray(array)->GetRange();
    std::cout << arrays->GetArray(array)->GetName() << ": " << range[0] << " to " << range[1]
              << "\n";
  }
}
