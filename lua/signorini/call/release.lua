-- The program's version with a hash of its source, on which results depend: "0.1.0 (3f2a91c0d4e5b687)". A change of
-- share, scripts and tests keeps it.
return require("signorini.core").release()
