/**
 * @class   RecentFiles
 * @brief   what was opened before, remembered from one start to the next
 */

#ifndef RecentFiles_h
#define RecentFiles_h

#include <QObject>
#include <QStringList>

namespace penumbra
{

class RecentFiles : public QObject
{
  Q_OBJECT
public:
  static constexpr int Most = 10;

  using QObject::QObject;

  /// The last one first; those that are there no longer are left out.
  QStringList Get() const;

  void Add(const QString& file);
  void Clear();

signals:
  void changed();
};

}

#endif
