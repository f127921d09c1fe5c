/**
 * @file    Picture.h
 * @brief   what a window shows, and the files that can hold it
 */

#ifndef Picture_h
#define Picture_h

#include <vtkSmartPointer.h>

#include <filesystem>
#include <string>

class vtkImageData;
class vtkRenderWindow;

namespace penumbra
{

enum class PictureFormat
{
  /// 8 bits RGB.
  Png,
  /// MetaImage: float32 RGBA over 255, not compressed, local data, bottom row first.
  Mha
};

/**
 * The format that a file's name asks for.
 * @throw InputError where it asks for another than these.
 */
PictureFormat FormatOf(const std::filesystem::path& file);

/// The 8-bit RGBA picture that the window holds, bottom row first. Does not render.
vtkSmartPointer<vtkImageData> ReadPicture(vtkRenderWindow* window);

/// The picture in 8 bits a channel, rounded; of ReadPicture's, or of floats from 0 to 1.
vtkSmartPointer<vtkImageData> ToBytes(vtkImageData* picture);

/// The bytes of a file that holds the picture: of ReadPicture, or floats from 0 to 1.
std::string EncodePicture(vtkImageData* picture, PictureFormat format);

}

#endif
