#include "input/pose_options.h"

#include "input/failure.h"

namespace evenlift::native {
void PoseFileOptions::declare(CommandLine& line) {
  line.value(file, "--poses", "OUT",
             "also write the robots' poses: OUT ends in .csv, .json or .yaml");
  line.value(frame, "--frame", "NAME", "the poses' coordinate frame (default object)");
  line.value(origin, "--origin", "WHERE", "origin of the poses: file (default) or com");
}

std::optional<PosesAsked> PoseFileOptions::asked() const {
  for (const auto& [option, typed] : {std::pair("--frame", &frame), {"--origin", &origin}})
    if (*typed && !file) throw Failure{bad_input_status, option, "applies only to --poses"};
  if (!file) return std::nullopt;
  const auto format = pose_format_of_file(*file);
  if (!format)
    throw bad_value("--poses", "the name of a file of poses must end in .csv, .json or .yaml",
                    *file);
  PosesAsked asked{*file, *format, {}};
  if (frame) {
    if (*format == PoseFormat::csv)
      throw Failure{bad_input_status, "--frame", "a table (CSV) contains no frame"};
    if (!is_frame_name(*frame)) throw bad_value("--frame", frame_requirement, *frame);
    asked.options.frame = *frame;
  }
  if (origin) {
    const auto known = pose_origin_from_name(*origin);
    if (!known) throw bad_value("--origin", pose_origin_requirement, *origin);
    asked.options.origin = *known;
  }
  return asked;
}

}  // namespace evenlift::native
