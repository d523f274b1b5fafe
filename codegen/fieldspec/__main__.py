"""`python -m fieldspec`"""

import sys

from fieldspec.cli import main

sys.exit(main())
