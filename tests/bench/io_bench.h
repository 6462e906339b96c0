/// Reading and writing a million points, compared with the same bytes moved by fread and fwrite.
#pragma once

namespace se::bench {

/// Rows io/...: not run unless requested, as they need 300 MB in the folder for temporary files.
void registerIo();

}  // namespace se::bench
