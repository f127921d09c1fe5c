/**
 * @class   ProgressLine
 * @brief   one line on the terminal that counts up to 100 %
 *
 * Nothing is written where stderr is no terminal.
 */

#ifndef ProgressLine_h
#define ProgressLine_h

#include <string>

namespace penumbra
{

class ProgressLine
{
public:
  /// `what` is being done.
  explicit ProgressLine(const std::string& what);

  /// Ends the line.
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// `part` of it is done, 0 to 1.
  void Tell(double part);

private:
  std::string What;
  bool IsShown;
  int Percent = 0;
};

}

#endif
