/** The compiler of syntax trees into nodes. Knows neither the language nor its callers. */
package dev.eventchain.ocl.lower;
