/** The one door through which files are written, and what people wrote in them. */
package dev.eventchain.output;
