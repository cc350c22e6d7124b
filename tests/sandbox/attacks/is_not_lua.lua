-- Is not Lua.
-- expect: recipe error
<?php system("id"); ?>
