import './help.ts';
import './legend.ts';
import './notice.ts';
import './panel.ts';
import './status.ts';
import './tool-strip.ts';
import './topbar.ts';
import './viewbar.ts';
