/**
 * @class   RenderingError
 * @brief   why a valid scene could not be rendered
 *
 * what() is one line.
 */

#ifndef RenderingError_h
#define RenderingError_h

#include <stdexcept>

namespace penumbra
{

class RenderingError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

}

#endif
