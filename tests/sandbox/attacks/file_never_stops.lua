-- Never stops before it returns a recipe.
-- expect: recipe error
-- says: for more than
while true do end
