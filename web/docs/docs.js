/**
 * The page about the interface is written by the service; here it gets the colours of the other
 * page.
 */

import { startTheme } from '../lib/theme.js';

startTheme();
