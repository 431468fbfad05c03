/** OCL as plain text: its lexer and tokens. Independent of metamodels. */
package dev.eventchain.ocl.text;
