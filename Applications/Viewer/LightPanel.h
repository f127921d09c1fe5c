/**
 * @class   LightPanel
 * @brief   the lights of the scene: a list of them, and the controls of the selected one
 */

#ifndef LightPanel_h
#define LightPanel_h

#include "Vector3.h"

#include <QWidget>

class QAction;
class QLabel;
class QListWidget;
class QListWidgetItem;
class QToolButton;

namespace penumbra
{

class DirectionBall;
class SceneDocument;
class VolumeView;
enum class LightType;

class LightPanel : public QWidget
{
  Q_OBJECT
public:
  LightPanel(SceneDocument* document, VolumeView* view, QWidget* parent = nullptr);

  /// What can be done with lights, for a menu.
  ///@{
  const QList<QAction*>& GetAddActions() const { return this->AddActions; }
  const QList<QAction*>& GetRigActions() const { return this->RigActions; }
  QAction* GetCopyAction() const { return this->CopyAction; }
  QAction* GetRemoveAction() const { return this->RemoveAction; }
  QAction* GetResetAction() const { return this->ResetAction; }
  ///@}

  /// Lets the selected light shine at a point of the world.
  void AimSelected(const Vector3& target);

private:
  void MakeActions();
  QWidget* MakeButtons();
  QWidget* MakePages();
  void Add(LightType type);
  void CopySelected();
  void RemoveSelected();
  void UseRig(int rig);
  void Reset();
  void TurnSelected(const Vector3& toLight);
  void SwitchLight(QListWidgetItem* item);
  void Refresh();
  void ShowDirection();

  SceneDocument* Document;
  VolumeView* View;
  QListWidget* List;
  QLabel* Hint = nullptr;
  DirectionBall* Ball = nullptr;
  QToolButton* AddButton = nullptr;
  QToolButton* RigButton = nullptr;
  QList<QAction*> AddActions;
  QList<QAction*> RigActions;
  QAction* CopyAction = nullptr;
  QAction* RemoveAction = nullptr;
  QAction* ResetAction = nullptr;
};

}

#endif
