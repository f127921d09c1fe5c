/**
 * @class   SeriesDialog
 * @brief   lets one choose among the series of a DICOM folder
 */

#ifndef SeriesDialog_h
#define SeriesDialog_h

#include "SeriesList.h"

#include <QDialog>

class QTableWidget;

namespace penumbra
{

class SeriesDialog : public QDialog
{
  Q_OBJECT
public:
  explicit SeriesDialog(const std::vector<SeriesFacts>& series, QWidget* parent = nullptr);

  const SeriesFacts& GetChosen() const;

private:
  std::vector<SeriesFacts> Series;
  QTableWidget* Table;
};

}

#endif
