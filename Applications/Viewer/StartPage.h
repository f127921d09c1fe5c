/**
 * @class   StartPage
 * @brief   what the window shows before anything is open
 */

#ifndef StartPage_h
#define StartPage_h

#include <QWidget>

class QPushButton;
class QVBoxLayout;

namespace penumbra
{

class StartPage : public QWidget
{
  Q_OBJECT
public:
  explicit StartPage(QWidget* parent = nullptr);

  /// Files that were open before, the last one first.
  void ShowRecent(const QStringList& files);

  /// Shows a button for a scene.
  void SetExample(const QString& file);

signals:
  void folderAsked();
  void fileAsked();
  void chosen(const QString& file);

private:
  QPushButton* AddButton(const QString& text, const QString& explanation);

  QVBoxLayout* Column;
  QPushButton* Example;
  QWidget* Recent;
};

}

#endif
