/** What a client may read and change: files, results as tables, changes on a copy. */
package dev.eventchain.mcp.project;
