/**
 * @class   RawImportDialog
 * @brief   asks what a .raw file does not say about itself
 *
 * Header and voxels have to fill the file exactly; whether they do is told at each change, and only
 * then the file can be opened.
 */

#ifndef RawImportDialog_h
#define RawImportDialog_h

#include "RawLayout.h"

#include <QDialog>

class QComboBox;
class QDialogButtonBox;
class QFormLayout;
class QLabel;
class QSpinBox;

namespace penumbra
{

class VectorEdit;

class RawImportDialog : public QDialog
{
  Q_OBJECT
public:
  explicit RawImportDialog(const QString& file, QWidget* parent = nullptr);

  const RawLayout& GetLayout() const { return this->Layout; }

private:
  void AddProposals(QFormLayout* form);
  void AddControls(QFormLayout* form);
  void ShowLayout();
  void TakeLayout();
  void CheckSize();

  RawLayout Layout;
  std::vector<RawLayout> Proposals;
  std::uint64_t FileBytes;
  std::array<QSpinBox*, 3> Dimensions{};
  QComboBox* Type = nullptr;
  QComboBox* ByteOrder = nullptr;
  QSpinBox* Header = nullptr;
  VectorEdit* Spacing = nullptr;
  QLabel* Verdict = nullptr;
  QDialogButtonBox* Buttons = nullptr;
};

}

#endif
