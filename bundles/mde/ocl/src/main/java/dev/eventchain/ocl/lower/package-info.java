/** The compiler of syntax trees into nodes. Independent of the language and its callers. */
package dev.eventchain.ocl.lower;
