"""python -m pylmp"""

import sys

from pylmp.cli import main

sys.exit(main())
