//b/c.js
