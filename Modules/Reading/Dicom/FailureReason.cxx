#include "FailureReason.h"

#include "VolumeReadingError.h"

#include <new>
#include <stdexcept>

namespace penumbra
{

std::string FailureReason(const std::exception& error)
{
  if (dynamic_cast<const VolumeReadingError*>(&error))
  {
    return error.what();
  }
  if (dynamic_cast<const std::bad_alloc*>(&error) || dynamic_cast<const std::length_error*>(&error))
  {
    return "there is not enough memory for it";
  }
  return "the DICOM library fails on it; it is damaged";
}

}
