/**
 * @file    StabilityStudy.h
 * @brief   what comes out in stiff and extreme cases, and what VTK's own mapper makes of them
 */

#ifndef StabilityStudy_h
#define StabilityStudy_h

#include "RenderProgram.h"
#include "StabilityCases.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace penumbra
{

/// What one renderer made of a case.
struct StabilityOutcome
{
  bool IsRight = false;
  /// "RMSE 0.31", "refused: ...", "blank", "crashed", ...
  std::string Words;
};

struct StabilityRow
{
  std::string Case;
  /// "within 1 of 255" or "refused".
  std::string Expected;
  StabilityOutcome Penumbra;
  StabilityOutcome StockMapper;
};

/// `folder` takes volumes, scenes and pictures; `progress` may be empty.
std::vector<StabilityRow> RunStabilityStudy(const std::vector<StabilityCase>& cases,
  const RenderProgram& program, const std::filesystem::path& folder,
  const std::function<void(double)>& progress);

std::string WriteStabilityCsv(const std::vector<StabilityRow>& rows);
std::string WriteStabilityJson(const std::vector<StabilityRow>& rows, const std::string& command);
std::string WriteStabilityMarkdown(const std::vector<StabilityRow>& rows);

/// How many cases are right, with both.
std::string SummarizeStability(const std::vector<StabilityRow>& rows);

}

#endif
