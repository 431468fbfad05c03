/** Output folders, through which all files are written, and protected areas. */
package dev.eventchain.output;
