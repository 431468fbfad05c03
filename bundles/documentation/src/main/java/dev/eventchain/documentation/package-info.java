/** Makes the site for users from Markdown, the help of the commands and the rule pages. */
package dev.eventchain.documentation;
