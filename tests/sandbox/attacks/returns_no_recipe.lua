-- Returns no recipe.
-- expect: recipe error
-- says: returns
return 42
