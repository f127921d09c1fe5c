/**
 * @class   ReaderErrors
 * @brief   what VTK's objects say is wrong, kept from stderr
 */

#ifndef ReaderErrors_h
#define ReaderErrors_h

#include "vtkCallbackCommand.h"
#include "vtkNew.h"

#include <string>

namespace penumbra
{

/**
 * Must outlive the objects it observes.
 */
class ReaderErrors
{
public:
  ReaderErrors();
  ReaderErrors(const ReaderErrors&) = delete;
  ReaderErrors& operator=(const ReaderErrors&) = delete;

  /**
   * From now on errors and warnings of `object` come here. Warnings end here.
   */
  void Observe(vtkObject* object);

  /**
   * Throws VolumeReadingError with the first error if there was one.
   */
  void ThrowIfAny() const;

private:
  vtkNew<vtkCallbackCommand> Listener;
  std::string First;
};

}

#endif
