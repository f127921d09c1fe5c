/**
 * @class   InformationPanel
 * @brief   what is known of the volume: size, spacing, values, modality, memory
 */

#ifndef InformationPanel_h
#define InformationPanel_h

#include <QStringList>
#include <QWidget>

class QLabel;

namespace penumbra
{

class SceneDocument;

class InformationPanel : public QWidget
{
  Q_OBJECT
public:
  explicit InformationPanel(SceneDocument* document, QWidget* parent = nullptr);

  /// What was chosen for the volume and what a user should know of it.
  void ShowNotes(const QStringList& notes);

private:
  void Refresh();

  SceneDocument* Document;
  QLabel* Facts;
  QLabel* Notes;
};

}

#endif
