/** The server for coding agents: the commands over the Model Context Protocol. */
package dev.eventchain.mcp;
