/**
 * @class   PictureActions
 * @brief   pictures of the scene: to a file at any size, to the clipboard, as a turntable
 */

#ifndef PictureActions_h
#define PictureActions_h

#include <QObject>

#include <array>
#include <filesystem>

class QMenu;
class QImage;

namespace penumbra
{

class MainWindow;

class PictureActions : public QObject
{
  Q_OBJECT
public:
  explicit PictureActions(MainWindow* window);

  void Fill(QMenu* fileMenu, QMenu* editMenu);

  /// Each throws InputError or RenderingError where it fails.
  ///@{
  /// The scene as it is seen, in this size, as penumbra-render renders it.
  QImage Draw(const std::array<int, 2>& size);
  void SavePicture(const std::filesystem::path& file, const std::array<int, 2>& size);
  /**
   * The camera once around the focal point about the view-up axis: as `file` without its extension
   * and 0000.png and so on, or one video where it ends in .ogv. Returns the number of pictures,
   * fewer than `frames` where it was canceled.
   */
  int SaveTurntable(const std::filesystem::path& file, const std::array<int, 2>& size, int frames);
  ///@}

  void Copy();

private:
  void AskForPicture();
  void AskForTurntable();

  MainWindow* Window;
};

}

#endif
