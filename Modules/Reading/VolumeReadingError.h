/**
 * @class   VolumeReadingError
 * @brief   why a volume file cannot be read
 *
 * what() is one line: which file, what is wrong with it and what would be right.
 */

#ifndef VolumeReadingError_h
#define VolumeReadingError_h

#include "PenumbraReadingModule.h" // For export macro

#include <stdexcept>

namespace penumbra
{

class PENUMBRAREADING_EXPORT VolumeReadingError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

}

#endif
