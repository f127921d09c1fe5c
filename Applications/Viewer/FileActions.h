/**
 * @class   FileActions
 * @brief   the menu of files: open, save, recent
 */

#ifndef FileActions_h
#define FileActions_h

#include <QObject>

#include <functional>

class QAction;
class QMenu;
class QToolBar;

namespace penumbra
{

class MainWindow;
class RecentFiles;

class FileActions : public QObject
{
  Q_OBJECT
public:
  FileActions(MainWindow* window, RecentFiles* recent);

  void Fill(QMenu* menu, QToolBar* bar);

  void AskForFile();
  void AskForFolder();

  /// Saves under the scene's own name, or asks for one. Returns whether it was saved.
  bool Save();
  bool SaveAs();

  /// Asks what shall become of changes that are not saved. Returns whether to go on.
  bool MayDiscardChanges();

private:
  QAction* Add(QMenu* menu, const QString& text, const QKeySequence& keys, const QString& tip,
    const std::function<void()>& task);
  bool SaveTo(const QString& file);
  void FillRecent(QMenu* menu);
  void Refresh();
  QString LastFolder() const;
  void RememberFolder(const QString& file);

  MainWindow* Window;
  RecentFiles* Recent;
  QAction* SaveAction = nullptr;
  QAction* SaveAsAction = nullptr;
};

}

#endif
