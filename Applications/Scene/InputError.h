/**
 * @class   InputError
 * @brief   what is wrong with a scene, a setting or a file that was asked for
 *
 * what() is one line: the key or file, its value and what is accepted.
 */

#ifndef InputError_h
#define InputError_h

#include <stdexcept>

namespace penumbra
{

class InputError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

}

#endif
