-- Never stops before it returns a recipe.
-- expect: recipe error
-- says: for more than
-- script: 0.2 s
while true do end
