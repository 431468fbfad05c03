/** OCL as plain text: its lexer and tokens. Knows no metamodel. */
package dev.eventchain.ocl.text;
