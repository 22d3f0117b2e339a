/// Winches in the time steps of a run: see mechanics/winch.h for tables and laws. A winch is given to a line by
/// Attachment::winch of the end that it holds; what it has paid out is AttachmentState::winch.
#pragma once

#include "mechanics/winch.h"
