#include "RecentFiles.h"

#include <QFileInfo>
#include <QSettings>

namespace penumbra
{
namespace
{
constexpr const char* Key = "recentFiles";
}

//------------------------------------------------------------------------------
QStringList RecentFiles::Get() const
{
  QStringList files;
  for (const QString& file : QSettings().value(Key).toStringList())
  {
    if (QFileInfo::exists(file))
    {
      files << file;
    }
  }
  return files;
}

//------------------------------------------------------------------------------
void RecentFiles::Add(const QString& file)
{
  const QString path = QFileInfo(file).absoluteFilePath();
  QStringList files = this->Get();
  files.removeAll(path);
  files.prepend(path);
  QSettings().setValue(Key, QStringList(files.mid(0, Most)));
  emit this->changed();
}

//------------------------------------------------------------------------------
void RecentFiles::Clear()
{
  QSettings().remove(Key);
  emit this->changed();
}

}
