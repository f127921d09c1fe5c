/**
 * @class   vtkMessageCollector
 * @brief   keeps VTK's errors and warnings instead of printing them
 *
 * Each message is kept once, in one line and without VTK's file, line and object.
 */

#ifndef vtkMessageCollector_h
#define vtkMessageCollector_h

#include <vtkOutputWindow.h>

#include <string>
#include <vector>

class vtkMessageCollector : public vtkOutputWindow
{
public:
  static vtkMessageCollector* New();
  vtkTypeMacro(vtkMessageCollector, vtkOutputWindow);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Makes this what all of VTK speaks to, and silences VTK's log on stderr.
   */
  void Install();

  void DisplayText(const char* text) override;
  void DisplayErrorText(const char* text) override;
  void DisplayWarningText(const char* text) override;
  void DisplayGenericWarningText(const char* text) override;
  void DisplayDebugText(const char* text) override;

  const std::vector<std::string>& GetErrors() const { return this->Errors; }
  const std::vector<std::string>& GetWarnings() const { return this->Warnings; }

protected:
  vtkMessageCollector();
  ~vtkMessageCollector() override;

private:
  vtkMessageCollector(const vtkMessageCollector&) = delete;
  void operator=(const vtkMessageCollector&) = delete;

  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;
};

#endif
