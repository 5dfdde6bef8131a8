// The line protocol of the movement course (docs/course-protocol.md) for movers under node: reads runs and ticks, hands
// them to a mover, and says where it is.
import { createInterface } from 'node:readline';
import { writeSync } from 'node:fs';

// A full pipe is no reason to give up.
function say(line) {
    let rest = Buffer.from(line + '\n');
    while (rest.length > 0) {
        try {
            rest = rest.subarray(writeSync(1, rest));
        } catch (error) {
            if (error.code !== 'EAGAIN') throw error;
        }
    }
}

const pose_of = (n) => ({
    position: { x: n[0], y: n[1], z: n[2] },
    rotation: { w: n[3], x: n[4], y: n[5], z: n[6] },
});

// `mover` has load({settings, bodies, start}) and tick({dt, wish, jump, poses}) -> {x, y, z, grounded}; `poses` are
// [body number, pose]. A body is {number, vertices, indices, pose, moves}.
export async function speak(mover) {
    let run = null;
    let body = null;
    let poses = [];
    for await (const line of createInterface({ input: process.stdin })) {
        const words = line.split(' ');
        const numbers = words.slice(1).map(Number);
        switch (words[0]) {
            case 'surefoot-course':
                say('surefoot-course 1');
                break;
            case 'run':
                run = { settings: {}, bodies: [], start: null };
                poses = [];
                break;
            case 'set':
                run.settings[words[1]] = numbers[1];
                break;
            case 'body':
                body = { number: numbers[0], vertices: [], indices: [], pose: pose_of(numbers.slice(3)), moves: false };
                run.bodies.push(body);
                break;
            case 'v':
                body.vertices.push(...numbers);
                break;
            case 'f':
                body.indices.push(...numbers);
                break;
            case 'moves':
                body.moves = true;
                break;
            case 'start':
                run.start = { x: numbers[0], y: numbers[1], z: numbers[2] };
                break;
            case 'go':
                mover.load(run);
                say('ready');
                break;
            case 'pose':
                poses.push([numbers[0], pose_of(numbers.slice(1))]);
                break;
            case 'tick': {
                const [dt, x, y, z, jump] = numbers;
                const at = mover.tick({ dt, wish: { x, y, z }, jump: jump === 1, poses });
                say(`at ${at.x} ${at.y} ${at.z} ${at.grounded ? 1 : 0}`);
                poses = [];
                break;
            }
        }
    }
}
