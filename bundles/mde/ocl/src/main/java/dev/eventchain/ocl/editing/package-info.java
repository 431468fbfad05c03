/**
 * Facts about expressions for editors: what each name in a syntax tree means, and what a type
 * offers. Independent of texts that are not complete.
 */
package dev.eventchain.ocl.editing;
