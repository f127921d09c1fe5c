/**
 * @class   SizeDialog
 * @brief   asks for the size of a picture in pixels
 */

#ifndef SizeDialog_h
#define SizeDialog_h

#include <QDialog>

#include <array>

class QFormLayout;
class QSpinBox;

namespace penumbra
{

class SizeDialog : public QDialog
{
  Q_OBJECT
public:
  SizeDialog(const QString& title, const std::array<int, 2>& size, QWidget* parent);

  /// Asks for a number too.
  void AddNumber(const QString& label, int value, int lowest, int highest);

  std::array<int, 2> GetSize() const;
  int GetNumber() const;

private:
  QSpinBox* AddBox(const QString& label, int value, int lowest, int highest);

  QFormLayout* Form;
  QSpinBox* Width;
  QSpinBox* Height;
  QSpinBox* Number = nullptr;
};

}

#endif
