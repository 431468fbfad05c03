/** What editors can know about texts with expressions, whatever is around these. */
package dev.eventchain.ocl.assist;
