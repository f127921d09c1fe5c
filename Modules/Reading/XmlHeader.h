/**
 * @file    XmlHeader.h
 * @brief   what the elements of a VTI file say of its volume
 *
 * All throw VolumeReadingError where it is not one volume of one scalar per voxel.
 */

#ifndef XmlHeader_h
#define XmlHeader_h

#include <filesystem>
#include <string>
#include <vector>

class vtkXMLDataElement;
class vtkXMLDataParser;

namespace penumbra
{

struct VolumeGeometry;
struct XmlVoxels;

/**
 * The array within the element ImageData that PointData names as its scalars, or else, with a
 * warning, its first.
 */
vtkXMLDataElement* XmlScalars(vtkXMLDataElement* image, std::vector<std::string>& warnings);

/**
 * The geometry with the index of the first voxel moved to (0, 0, 0).
 */
VolumeGeometry XmlGeometry(vtkXMLDataElement* image);

/**
 * As VTK's constant.
 */
int XmlScalarType(vtkXMLDataElement* array);

/**
 * Where in the file the voxels of `array` are.
 */
XmlVoxels WhereVoxelsAre(
  const std::filesystem::path& path, vtkXMLDataElement* array, vtkXMLDataParser* parser);

}

#endif
