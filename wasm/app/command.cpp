#include "state/command.h"

namespace evenlift::view {

std::shared_ptr<AnyCommand> Command::owned(AnyCommand* command) {
  return std::shared_ptr<AnyCommand>(command);
}

}  // namespace evenlift::view
