/**
 * @class   ReadingProgress
 * @brief   how far reading is, with a button that cancels it
 */

#ifndef ReadingProgress_h
#define ReadingProgress_h

#include <QWidget>

class QLabel;
class QProgressBar;

namespace penumbra
{

class SceneOpening;

class ReadingProgress : public QWidget
{
  Q_OBJECT
public:
  explicit ReadingProgress(SceneOpening* opening, QWidget* parent = nullptr);

  void Begin(const QString& file);

private:
  QLabel* Label;
  QProgressBar* Bar;
};

}

#endif
