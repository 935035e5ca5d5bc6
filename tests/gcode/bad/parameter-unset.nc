; 2:1: error: the parameter #<depth> was never set [parameter-unset]
X#<depth>
