/**
 * @class   QualityLabel
 * @brief   what the length of the steps costs: the typical error, and the time of a whole picture
 *
 * The time is the last whole picture's. Where steps have changed since, it is scaled by what the
 * study found.
 */

#ifndef QualityLabel_h
#define QualityLabel_h

#include <QLabel>

namespace penumbra
{

class SceneDocument;
class VolumeView;

class QualityLabel : public QLabel
{
  Q_OBJECT
public:
  QualityLabel(SceneDocument* document, VolumeView* view, QWidget* parent = nullptr);

private:
  double GetStep() const;
  void NoteTime(double seconds);
  void Refresh();

  SceneDocument* Document;
  /// Of the last whole picture; 0: there was none yet.
  ///@{
  double Seconds = 0.0;
  double Step = 1.0;
  ///@}
};

}

#endif
