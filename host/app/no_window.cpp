// `nicol preview` where the window's libraries are missing.
#include "host/app/preview_command.hpp"

namespace nicol::app {

int preview_command(const PreviewCommand&) {
  throw UsageError(
      "this nicol was built without its preview window: libglfw3-dev, libepoxy-dev, libimgui-dev and libstb-dev were "
      "not there (`./nicol preview` installs them and builds again)");
}

}  // namespace nicol::app
