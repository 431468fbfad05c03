/** The project as a client may read and change it: files, results as tables, changes on a copy. */
package dev.eventchain.mcp.project;
