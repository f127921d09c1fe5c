/**
 * @file    ErrorReport.h
 * @brief   what the error study found, as tables, charts and one line
 */

#ifndef ErrorReport_h
#define ErrorReport_h

#include "ErrorStudy.h"
#include "StudyChart.h"

#include <string>
#include <vector>

namespace penumbra
{

/// The rows of a scene that no other is both faster and more accurate than, by time.
std::vector<ErrorRow> ParetoFront(const std::vector<ErrorRow>& rows, const std::string& scene);

/// Comma-separated values with one line a row and names at the top.
std::string WriteErrorCsv(const ErrorStudyResult& result);

/// `command` made it.
std::string WriteErrorJson(const ErrorStudyResult& result, const std::string& command);

/// A table a scene, in Markdown.
std::string WriteErrorMarkdown(const ErrorStudyResult& result);

/// Error over time, and error over step, of one scene.
ChartDescription ChartOfTime(const ErrorStudyResult& result, const std::string& scene);
ChartDescription ChartOfStep(const ErrorStudyResult& result, const std::string& scene);

/// The scenes in their order.
std::vector<std::string> ScenesOf(const ErrorStudyResult& result);

struct ErrorSummary
{
  std::string Line;
  bool WithinBounds = true;
};

/// Penumbra's rays at the default step within 1 grey level of 255, at the finest within 0.5.
ErrorSummary Summarize(const ErrorStudyResult& result);

}

#endif
