/**
 * @class   AppearancePanel
 * @brief   what the volume looks like: presets, transfer function, material
 */

#ifndef AppearancePanel_h
#define AppearancePanel_h

#include <QWidget>

namespace penumbra
{

class PresetPanel;
class SceneDocument;
class TransferFunctionPanel;
class VolumeView;

class AppearancePanel : public QWidget
{
  Q_OBJECT
public:
  AppearancePanel(SceneDocument* document, VolumeView* view, QWidget* parent = nullptr);

  PresetPanel* GetPresets() { return this->Presets; }
  TransferFunctionPanel* GetTransferFunction() { return this->TransferFunction; }

private:
  PresetPanel* Presets;
  TransferFunctionPanel* TransferFunction;
};

}

#endif
