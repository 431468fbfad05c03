/** OCL as plain text: its lexer, tokens and keywords. Independent of metamodels. */
package dev.eventchain.ocl.text;
