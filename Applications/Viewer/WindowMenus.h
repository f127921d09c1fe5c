/**
 * @file    WindowMenus.h
 * @brief   the menus and the tool bar of the main window
 */

#ifndef WindowMenus_h
#define WindowMenus_h

class QMainWindow;

namespace penumbra
{

class FileActions;
class PictureActions;
class SceneDocument;
class ViewHandles;
class VolumeView;
class WindowPanels;

/// What menus act on; it lives as long as the window.
struct WindowParts
{
  SceneDocument* Document;
  VolumeView* View;
  FileActions* Files;
  PictureActions* Pictures;
  ViewHandles* Handles;
  WindowPanels* Panels;
};

void FillMenus(QMainWindow* window, const WindowParts& parts);

}

#endif
